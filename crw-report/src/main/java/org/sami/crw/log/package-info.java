/**
 * The old boats' vehicle logs (text, one line an entry, 2013 and 2015): read line by line, made into tracks, tables and a
 * picture.
 *
 * <p>Here belong the form of those logs and what is made of them; memory does not grow with a log's length. How a track
 * is drawn belongs to {@code crw.report}, the options to {@code crw.cli}. The log of our own boat server is
 * another one ({@code boat.server.log}).
 */
@NullMarked
package org.sami.crw.log;

import org.jspecify.annotations.NullMarked;
