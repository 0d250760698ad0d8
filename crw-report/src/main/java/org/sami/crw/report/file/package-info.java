/**
 * The files of a report: the folder with JSON, tables and map, and the formats of other programs (GeoJSON, GPX, KML).
 *
 * <p>Here belongs how a report is written. What it says belongs to {@code crw.report}, how the map is drawn to {@code crw.report.picture}.
 */
@NullMarked
package org.sami.crw.report.file;

import org.jspecify.annotations.NullMarked;
