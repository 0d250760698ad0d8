/** The frame: its commands, menus, strip at the top, and how panels lie in it. What a panel shows stands in the panel's package. */
@NullMarked
package org.sami.crw.gui.window;

import org.jspecify.annotations.NullMarked;
