/**
 * The operator's window over a session in another process: the window itself, and how its connection stands. What the panels show and do belongs to them.
 */
@NullMarked
package org.sami.crw.gui.remote;

import org.jspecify.annotations.NullMarked;
