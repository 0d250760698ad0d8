package org.sami.mavlink.param;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.common.ParamRequestList;
import io.dronefleet.mavlink.common.ParamRequestRead;
import io.dronefleet.mavlink.common.ParamSet;
import io.dronefleet.mavlink.common.ParamValue;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.mavlink.testing.BadRadio;
import org.sami.mavlink.vehicle.VehicleId;

/** Parameters of a vehicle that has 300, on a clock of the test's own. */
class VehicleParametersTest {
    private static final VehicleId VEHICLE = new VehicleId(3, 1);
    private static final int MANY = 300;
    private static final String FIXED = "P007";

    private final TreeMap<String, Float> held = new TreeMap<>();
    private final List<SortedMap<String, Double>> kept = new ArrayList<>();
    private BadRadio<Object> up = new BadRadio<>(1, 0, 0, 5, 0);
    private BadRadio<Object> down = new BadRadio<>(2, 0, 0, 5, 0);
    private long nowMs;

    VehicleParametersTest() {
        IntStream.range(0, MANY).forEach(i -> held.put(String.format("P%03d", i), i * 0.5f));
    }

    private VehicleParameters parameters() {
        return new VehicleParameters(VEHICLE, kept::add, message -> up.send(message, nowMs));
    }

    private void vehicle(Object message, Consumer<Object> send) {
        List<String> names = List.copyOf(held.keySet());
        if (message instanceof ParamRequestList) {
            names.forEach(name -> send.accept(value(name)));
        } else if (message instanceof ParamRequestRead one) {
            String name = one.paramIndex() < 0 ? one.paramId() : names.get(one.paramIndex());
            if (held.containsKey(name)) {
                send.accept(value(name));
            }
        } else if (message instanceof ParamSet set) {
            if (!set.paramId().equals(FIXED)) {
                held.put(set.paramId(), set.paramValue());
            }
            send.accept(value(set.paramId()));
        }
    }

    private ParamValue value(String name) {
        return ParamValue.builder()
                .paramId(name)
                .paramValue(held.get(name))
                .paramCount(held.size())
                .paramIndex(List.copyOf(held.keySet()).indexOf(name))
                .build();
    }

    private void passUntilDone(VehicleParameters parameters, CompletableFuture<?> result) {
        long began = nowMs;
        while (!result.isDone() && nowMs < began + 300_000) {
            nowMs += 5;
            up.arrived(nowMs).forEach(message -> vehicle(message, answer -> down.send(answer, nowMs)));
            down.arrived(nowMs).forEach(message -> parameters.take(message, nowMs));
            parameters.tick(nowMs);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, 0.2})
    void allAreReadAndKept(double loss) {
        up = new BadRadio<>(1, loss, loss, 5, 20);
        down = new BadRadio<>(2, loss, loss, 5, 20);
        VehicleParameters parameters = parameters();
        var result = parameters.readAll(nowMs);
        passUntilDone(parameters, result);

        assertThat(result.join()).hasSize(MANY).containsEntry("P299", 149.5);
        assertThat(kept).containsExactly(result.join());
    }

    @Test
    void oneIsSetReadBackAndKept() {
        VehicleParameters parameters = parameters();
        passUntilDone(parameters, parameters.readAll(nowMs));
        up = new BadRadio<>(7, 0.4, 0, 5, 20);
        var result = parameters.set("P001", 0.1, nowMs);
        passUntilDone(parameters, result);

        assertThat(result).isCompletedWithValue((double) 0.1f);
        assertThat(held.get("P001")).isEqualTo(0.1f);
        assertThat(kept.get(kept.size() - 1)).containsEntry("P001", (double) 0.1f);
    }

    @Test
    void valueThatTheVehicleDoesNotTakeIsNamed() {
        VehicleParameters parameters = parameters();
        var result = parameters.set(FIXED, 9, nowMs);
        passUntilDone(parameters, result);

        assertThat(result)
                .failsWithin(Duration.ZERO)
                .withThrowableThat()
                .withMessageContaining("vehicle 3 keeps P007 at 3.5 when it is set to 9.0");
    }

    @Test
    void parameterThatItDoesNotHaveIsNamed() {
        VehicleParameters parameters = parameters();
        var result = parameters.read("NOTHING", nowMs);
        passUntilDone(parameters, result);

        assertThat(result)
                .failsWithin(Duration.ZERO)
                .withThrowableThat()
                .withMessageContaining("vehicle 3 has no parameter NOTHING");
    }

    @Test
    void valuesThatCannotBeKeptAreSaidAndStopNothing(@TempDir Path folder) throws Exception {
        ParameterFiles files = new ParameterFiles(Files.writeString(folder.resolve("file"), ""));
        VehicleParameters parameters = new VehicleParameters(
                VEHICLE, values -> files.keep(VEHICLE, values), message -> up.send(message, nowMs));
        var result = parameters.readAll(nowMs);
        passUntilDone(parameters, result);

        assertThat(result).failsWithin(Duration.ZERO).withThrowableThat().withMessageContaining("cannot be kept");
        var one = parameters.read("P001", nowMs);
        passUntilDone(parameters, one);
        assertThat(one).isCompletedWithValue(0.5);
    }

    @Test
    void filesKeepThemByVehicle(@TempDir Path folder) throws Exception {
        ParameterFiles files = new ParameterFiles(folder.resolve("parameters"));
        SortedMap<String, Double> values = new TreeMap<>(Map.of("WP_SPEED", 1.5, "FS_GCS_ENABLE", 0.0));
        files.keep(VEHICLE, values);

        assertThat(files.load(VEHICLE)).map(KeptParameters::values).contains(values);
        assertThat(files.load(new VehicleId(4, 1))).isEmpty();
        assertThat(Files.readString(folder.resolve("parameters/vehicle-3.parm")))
                .isEqualTo(String.format("FS_GCS_ENABLE 0%nWP_SPEED 1.5%n"));
        Files.writeString(folder.resolve("parameters/vehicle-3.parm"), "WP_SPEED 1.5\nFS_GCS");
        assertThat(files.load(VEHICLE)).isEmpty();
    }

    @Test
    void whatHasChangedSinceItWasKeptIsSaidWithoutTheCountersOfTheAutopilot(@TempDir Path folder) throws Exception {
        ParameterFiles files = new ParameterFiles(folder);
        files.keep(
                VEHICLE,
                new TreeMap<>(Map.of(
                        "FENCE_ENABLE",
                        1.0,
                        "OLD",
                        2.0,
                        "STAT_BOOTCNT",
                        7.0,
                        "WP_RADIUS",
                        (double) 0.1f,
                        "ZERO",
                        0.0)));
        Instant since = Instant.parse("2026-11-30T10:02:00Z");
        Files.setLastModifiedTime(folder.resolve("vehicle-3.parm"), FileTime.from(since));

        KeptParameters kept = files.load(VEHICLE).orElseThrow();

        assertThat(kept.since()).isEqualTo(since);
        assertThat(kept.changes(new TreeMap<>(Map.of(
                        "FENCE_ENABLE",
                        0.0,
                        "NEW",
                        0.5,
                        "STAT_BOOTCNT",
                        8.0,
                        "WP_RADIUS",
                        (double) 0.1f,
                        "ZERO",
                        -0.0))))
                .containsExactly("FENCE_ENABLE 1 → 0", "NEW not there → 0.5", "OLD 2 → not there");
    }
}
