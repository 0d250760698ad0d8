/** Edits of a plan as a script: what a step shows, and how a solution is made from its start. */
@NullMarked
package org.sami.lessons.script;

import org.jspecify.annotations.NullMarked;
