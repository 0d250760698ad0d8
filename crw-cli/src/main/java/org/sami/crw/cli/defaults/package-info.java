/**
 * {@code crw defaults}: the numbers that hold where nobody says otherwise, each taken from the class, option or file that has it. What belongs here: which
 * they are, what they do and where they are set. What does not: the numbers themselves ({@code LinkDefaults}, {@code MotionDefaults} and others in their modules).
 */
@NullMarked
package org.sami.crw.cli.defaults;

import org.jspecify.annotations.NullMarked;
