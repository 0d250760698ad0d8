package org.sami.architecture.sample;

import org.sami.boat.link.BoatMode;

/** Knows a word of the boats, as no part of an editor may. */
public record KnowsABoat(BoatMode mode) {}
