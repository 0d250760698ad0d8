package org.sami.crw.handler.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.boat.link.BoatCapabilities;
import org.sami.spn.value.TextValue;

/** What plans ask of boats, and what boats say that they can do. */
class BoatDemandsTest {
    private static final BoatCapabilities BLIND =
            new BoatCapabilities(Map.of("panorama", "there is no camera on board"), Optional.empty());
    private static final BoatCapabilities SAMPLER =
            new BoatCapabilities(Map.of(), Optional.of(List.of("ctd/temperature", "ctd/oxygen")));

    private static Optional<String> measure(BoatCapabilities boatCan, String sensor) {
        return BoatDemands.missing("anna", boatCan, "TakeMeasurement", Map.of("sensor", new TextValue(sensor)));
    }

    @Test
    void boatWithoutACameraCannotTakePicturesAndSaysWhy() {
        assertThat(BoatDemands.missing("mav1", BLIND, "TakePanorama", Map.of()))
                .contains("mav1 cannot take pictures all round: there is no camera on board");
        assertThat(BoatDemands.missingEquipment(BLIND))
                .containsExactly("cannot take pictures all round: there is no camera on board");
    }

    @Test
    void boatThatReportsNoChargeCannotHaveItsChargeWatched() {
        BoatCapabilities unmeasured =
                new BoatCapabilities(Map.of("battery", "it has no current sensor"), Optional.empty());

        assertThat(BoatDemands.missing("mav1", unmeasured, "BatteryLevelSubscription", Map.of()))
                .contains("mav1 cannot report its charge: it has no current sensor");
        assertThat(BoatDemands.missing("mav1", BLIND, "BatteryLevelSubscription", Map.of()))
                .isEmpty();
    }

    @Test
    void boatThatSaysNothingIsTakenToBeAble() {
        assertThat(BoatDemands.missing("anna", BoatCapabilities.UNKNOWN, "TakePanorama", Map.of()))
                .isEmpty();
        assertThat(measure(BoatCapabilities.UNKNOWN, "temperature")).isEmpty();
        assertThat(measure(BLIND, "temperature")).isEmpty();
        assertThat(BoatDemands.missing("anna", BLIND, "ProxyExecutePath", Map.of()))
                .isEmpty();
    }

    @ParameterizedTest
    @ValueSource(strings = {"temperature", "ctd", "ctd/oxygen"})
    void sensorIsNamedByItsChannelItsInstrumentOrBoth(String sensor) {
        assertThat(measure(SAMPLER, sensor)).isEmpty();
    }

    @Test
    void sensorThatIsNotThereIsNamedWithThoseThatAre() {
        assertThat(measure(SAMPLER, "ph")).contains("anna cannot measure ph: it has ctd/temperature, ctd/oxygen");
        assertThat(measure(new BoatCapabilities(Map.of(), Optional.of(List.of())), "ph"))
                .contains("anna cannot measure ph: it has no sensors");
    }

    @Test
    void boatsOfferWhatTheySayAndNotACameraThatTheyLack() {
        assertThat(BoatDemands.offers(Set.of("winch"), SAMPLER))
                .containsExactly("camera", "ctd/oxygen", "ctd/temperature", "oxygen", "temperature", "winch");
        assertThat(BoatDemands.offers(Set.of("camera", "winch"), BLIND)).containsExactly("winch");
        assertThat(BoatDemands.offers(Set.of("winch"), BoatCapabilities.UNKNOWN))
                .containsExactly("winch");
    }
}
