/** Edits of a script that are played in the editor, on a copy, with a pointer that is drawn. */
@NullMarked
package org.sami.dreamm.learn.show;

import org.jspecify.annotations.NullMarked;
