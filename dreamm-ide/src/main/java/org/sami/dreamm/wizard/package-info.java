/** What an author adds to a plan, with the sequence that comes with it: the additions themselves, without Swing, and the strip that offers sequences. */
@NullMarked
package org.sami.dreamm.wizard;

import org.jspecify.annotations.NullMarked;
