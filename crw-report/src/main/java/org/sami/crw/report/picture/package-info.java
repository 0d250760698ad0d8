/**
 * The map of a run and the picture of a log's tracks, as PNG: what is drawn, by which scale and colours.
 *
 * <p>Drawn is what a report's records hold ({@code crw.report}). Which files a report consists of belongs to {@code crw.report.file}.
 */
@NullMarked
package org.sami.crw.report.picture;

import org.jspecify.annotations.NullMarked;
