/**
 * The project's file: opened, saved, changed by others, left behind by a process that was killed; and what is imported. The format itself stands in
 * {@code org.sami.spn.json}.
 */
@NullMarked
package org.sami.dreamm.file;

import org.jspecify.annotations.NullMarked;
