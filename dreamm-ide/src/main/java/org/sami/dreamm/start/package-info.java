/** How DREAMM begins: its command line, its folder of data, the project that is opened first. */
@NullMarked
package org.sami.dreamm.start;

import org.jspecify.annotations.NullMarked;
