/**
 * What services compute for activations: allocations, ways, places for an assembly, distances, and the exploration of areas, which is
 * planned and then driven.
 *
 * <p>{@link org.sami.crw.handler.planning.Computations} computes off the fleet's thread where there are threads for it. Does not
 * belong here: the algorithms ({@code org.sami.crw.service}).
 */
@NullMarked
package org.sami.crw.handler.planning;

import org.jspecify.annotations.NullMarked;
