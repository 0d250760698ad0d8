/**
 * The words of the course anywhere in the window: what a term means and where it is explained, under the pointer and by a key. Finds the words that components show;
 * what they mean is the glossary's.
 */
@NullMarked
package org.sami.dreamm.help.word;

import org.jspecify.annotations.NullMarked;
