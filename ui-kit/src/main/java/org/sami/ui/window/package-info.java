/**
 * The parts of a window other than its panels: saved settings, commands of its look, menus of commands, the line with the result of a
 * command, the lock of a folder. It knows no panel by name.
 */
@NullMarked
package org.sami.ui.window;

import org.jspecify.annotations.NullMarked;
