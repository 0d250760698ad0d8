/**
 * Fetching the files that boats keep, over links of their own as observers: logs and pictures, in pieces, resumed after a cut, with their hash checked. No part of
 * a mission, and on the threads of whoever fetches.
 */
@NullMarked
package org.sami.crw.proxy.file;

import org.jspecify.annotations.NullMarked;
