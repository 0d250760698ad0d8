/**
 * What a window has beside its panels, whatever they show: settings that are kept, commands of its look, menus of commands, the line that
 * tells what came of a command, the lock of a folder. It knows no panel by name.
 */
package org.sami.ui.window;
