/** The picture of a plan as a file: PNG, SVG or PDF. What it looks like is that of {@code org.sami.picture}. */
@NullMarked
package org.sami.dreamm.export;

import org.jspecify.annotations.NullMarked;
