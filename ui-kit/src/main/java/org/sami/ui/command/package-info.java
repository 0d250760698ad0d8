/**
 * What a person can have a window do: commands with a stable id, a name, a key and the reason why one cannot be run now; the keys that run
 * them, the search by typing, the list of keys. It knows no command by name.
 */
@NullMarked
package org.sami.ui.command;

import org.jspecify.annotations.NullMarked;
