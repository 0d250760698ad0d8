package org.sami.crw.gui.boat;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.sami.boat.link.LinkDefaults;
import org.sami.ui.map.ShownVehicle;

/** The map, which knows no boat's link, and the lists call what they show stale after the same time. */
class StaleTimeTest {
    @Test
    void mapFadesABoatWhenItsLinkIsLost() {
        assertThat(ShownVehicle.STALE_S * 1000).isEqualTo(LinkDefaults.LINK_LOST_AFTER_MS);
        assertThat(BoatWords.STALE_MS).isEqualTo(LinkDefaults.LINK_LOST_AFTER_MS);
    }
}
