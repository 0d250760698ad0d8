/** DREAMM, the window in which plans are written (thesis 5.1): the program itself. Its parts stand in the packages below. */
@NullMarked
package org.sami.dreamm;

import org.jspecify.annotations.NullMarked;
