package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.sim.layer.CurrentField;
import org.sami.crw.sim.layer.DepthGrid;
import org.sami.crw.sim.layer.WaterLayers;
import org.sami.crw.sim.vessel.ForeignVessels;

/** The water of a session's boats among the settings of its journal. */
class WaterAroundTest {
    private static final WaterAround LAKE = new WaterAround(
            ForeignVessels.parse("{\"format\": \"crw-vessels\", \"vessels\": [{\"name\": \"log\", \"length\": 3,"
                    + " \"beam\": 1, \"drifts\": true, \"track\": [{\"east\": 10, \"north\": 40}]}]}"),
            new WaterLayers(
                    Optional.of(
                            DepthGrid.parse("ncols 2\nnrows 2\nxllcorner 10\nyllcorner 45\ncellsize 0.1\n1 2\n3 4\n")),
                    Optional.of(CurrentField.parse("lat,lon,speed,direction\n45,10,0.2,90\n"))));

    @Test
    void whatIsWrittenIsReadAgain() {
        assertThat(WaterAround.of(LAKE.settings())).isEqualTo(LAKE);
        assertThat(WaterAround.NONE.settings()).isEmpty();
        assertThat(WaterAround.of(Map.of())).isEqualTo(WaterAround.NONE);
    }

    @Test
    void whatIsNamedAgainReplacesWhatThereWas() {
        CurrentField faster = CurrentField.parse("lat,lon,speed,direction\n45,10,0.9,90\n");
        WaterAround named =
                new WaterAround(ForeignVessels.NONE, new WaterLayers(Optional.empty(), Optional.of(faster)));

        WaterAround both = named.orAsBefore(LAKE);

        assertThat(both.layers().currents()).contains(faster);
        assertThat(both.layers().depths()).isEqualTo(LAKE.layers().depths());
        assertThat(both.vessels()).isEqualTo(LAKE.vessels());
    }
}
