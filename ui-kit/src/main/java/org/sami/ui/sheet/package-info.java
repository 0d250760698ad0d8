/**
 * What a window asks or shows over its panels without a dialog: a sheet inside the window, which never covers what must stay in sight and which
 * nothing waits for. It knows no panel.
 */
@NullMarked
package org.sami.ui.sheet;

import org.jspecify.annotations.NullMarked;
