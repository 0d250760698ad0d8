/** The operator's window: from the command line to a session and the window over it. Panels stand in the packages below. */
@NullMarked
package org.sami.crw.gui;

import org.jspecify.annotations.NullMarked;
