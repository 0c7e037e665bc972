// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 The pcl_msf authors
// The libraries' own headers first: what they can stand is theirs.
#include <pcl/io/pcd_io.h>
#include <pcl/registration/registration.h>
#include <pcl/search/kdtree.h>

#include <opencv2/core.hpp>

#include <array>
#include <atomic>
#include <chrono>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

// X11/X.h, X11/Xlib.h, X11/Xutil.h
#define None 0L
#define Bool int
#define Status int
#define True 1
#define False 0
#define Success 0
#define Above 0
#define Below 1
#define Always 2
#define Never 0
#define Complex 0
#define Convex 2
#define Nonconvex 1
#define Unsorted 0
#define Opposite 4
#define KeyPress 2
#define FocusIn 9
#define FocusOut 10
#define Expose 12
#define CursorShape 0
#define GrayScale 1
#define StaticColor 2
#define PseudoColor 3
#define TrueColor 4
#define DirectColor 5
#define InputOutput 1
#define InputOnly 2
#define Absolute 0
#define Nothing 0
#define NoValue 0
#define AllValues 15
// windows.h without NOMINMAX
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define near
#define far
#define small char
#define interface struct
#define IN
#define OUT
#define OPTIONAL
#define ERROR 0
#define NO_ERROR 0
#define DELETE 0x00010000L
#define STRICT 1
#define CONST const
#define VOID void
#define TRANSPARENT 1
#define OPAQUE 2
#define ABSOLUTE 1
#define RELATIVE 2
#define RGB(r, g, b) (r)
// Qt
#define signals public
#define slots
#define emit
#define foreach for
#define forever for (;;)
// complex.h, sys/sysmacros.h, termios.h, curses.h, Arduino.h
#define I 0
#define complex _Complex
#define imaginary _Imaginary
#define major(device) (device)
#define minor(device) (device)
#define makedev(a, b) (a)
#define unix 1
#define linux 1
#define B0 0
#define ECHO 8
#define TRUE 1
#define FALSE 0
#define OK 0
#define ERR (-1)
#define PI 3
#define HALF_PI 1
#define TWO_PI 6
#define DEFAULT 1
#define HIGH 1
#define LOW 0
#define INPUT 0
#define OUTPUT 1
#define radians(degrees) (degrees)
#define degrees(radians) (radians)
#define check(x) (x)
#define verify(x) (x)
#define require(x) (x)

#include "all_headers.h"

// The macros are still there for whoever wanted them.
static_assert (None == 0 && Convex == 2);
