/** The frame: its menus, its status line, and how panels lie in it. What a panel shows stands in the panel's package. */
@NullMarked
package org.sami.dreamm.window;

import org.jspecify.annotations.NullMarked;
