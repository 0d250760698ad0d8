package org.sami.crw.operator.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.crw.markup.MapRelevance.Visualization;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.spn.value.GeoPoint;

/** What is drawn where an operator switches sensor data, and no markup speaks of them. */
class SwitchedDataLayerTest {
    private final List<SensorLayer> drawn = new ArrayList<>();
    private final SensorFields fields = new SensorFields(Runnable::run, (channels, layers) -> {
        drawn.clear();
        drawn.addAll(layers);
    });
    private final LayerChoice choice = new LayerChoice(mission -> "mission " + mission);

    SwitchedDataLayerTest() {
        measured("hds", "depth", 4);
        measured("hds", "depth", 6);
        measured("ysi", "temperature", 20);
    }

    private void measured(String sensor, String channel, double value) {
        GeoPoint at = GeoPoint.of(45.7, 10.72 + value * 1e-4);
        fields.measured("anna", new BoatReading(sensor, channel, List.of(value), "", at, 0));
    }

    private List<String> drawnAt(long nowMillis) {
        fields.want(choice.requests(List.of(), Set.of("anna")));
        fields.look(nowMillis);
        return drawn.stream().map(layer -> layer.channel().toString()).toList();
    }

    @Test
    void nothingIsDrawnFromTheStart() {
        assertThat(drawnAt(0)).isEmpty();
    }

    @Test
    void theFirstChannelIsDrawnWhereTheLayerIsSwitchedOn() {
        choice.set(ShownLayer.SENSOR_DATA, Optional.of(true));

        assertThat(drawnAt(0)).containsExactly("hds/depth");
        assertThat(drawn.get(0).legend().greatest()).isEqualTo(6);
    }

    @Test
    void theChannelThatAPersonNamesIsDrawnAlone() {
        choice.set(ShownLayer.SENSOR_DATA, Optional.of(true));
        choice.showData(new SensorChannel("ysi", "temperature", ""), Optional.of(Visualization.HEATMAP));

        assertThat(drawnAt(0)).containsExactly("ysi/temperature");
    }

    @Test
    void nothingIsDrawnOnceTheLayerIsSwitchedOffOrLeftToMarkup() {
        choice.set(ShownLayer.SENSOR_DATA, Optional.of(true));
        assertThat(drawnAt(0)).hasSize(1);

        choice.set(ShownLayer.SENSOR_DATA, Optional.of(false));
        assertThat(drawnAt(1000)).isEmpty();
        choice.set(ShownLayer.SENSOR_DATA, Optional.empty());
        assertThat(drawnAt(2000)).isEmpty();
    }
}
