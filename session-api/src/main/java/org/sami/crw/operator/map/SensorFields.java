package org.sami.crw.operator.map;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.BiConsumer;
import org.sami.crw.markup.MapRelevance.Visualization;
import org.sami.crw.proxy.status.BoatReading;
import org.sami.crw.service.LocalPlane;
import org.sami.crw.service.field.ContourLine;
import org.sami.crw.service.field.FieldGrid;
import org.sami.crw.service.field.Legend;
import org.sami.crw.service.field.SampledField;

/**
 * What sensors measured, by channel and boat, and the layers that are computed of it: at most one computation a second, on an executor
 * that is no window's. May be called from any thread.
 */
public final class SensorFields {
    private static final long PERIOD_MILLIS = 1000;

    private final Executor computing;
    private final BiConsumer<List<SensorChannel>, List<SensorLayer>> computed;
    private volatile List<Request> wanted = List.of();

    // what follows is for the computing executor
    private final Map<SensorChannel, Map<String, SampledField>> fields = new TreeMap<>();
    private Optional<LocalPlane> plane = Optional.empty();
    private List<Request> answered = List.of();
    private boolean measured;
    private long computedAtMillis = Long.MIN_VALUE / 2;

    /**
     * A requested layer.
     *
     * @param word names the sensor or channel; empty text for the first channel of the boats
     * @param boats the boats of the readings; empty for all
     * @param threshold for that visualization; empty for the middle between least and greatest
     */
    record Request(String word, Visualization visualization, Set<String> boats, OptionalDouble threshold, String why) {
        Request {
            Objects.requireNonNull(word, "word");
            Objects.requireNonNull(visualization, "visualization");
            boats = Set.copyOf(boats);
            Objects.requireNonNull(threshold, "threshold");
            Objects.requireNonNull(why, "why");
        }
    }

    /**
     * Without readings.
     *
     * @param computing runs work one task after the other
     * @param computed receives all channels and the requested layers, on that executor
     */
    public SensorFields(Executor computing, BiConsumer<List<SensorChannel>, List<SensorLayer>> computed) {
        this.computing = computing;
        this.computed = computed;
    }

    /** A boat has measured; the first value of a reading counts. */
    public void measured(String boat, BoatReading reading) {
        execute(() -> {
            if (plane.isEmpty()) {
                plane = Optional.of(new LocalPlane(reading.position()));
            }
            SensorChannel channel = new SensorChannel(reading.sensor(), reading.channel(), reading.unit());
            fields.computeIfAbsent(channel, one -> new TreeMap<>())
                    .computeIfAbsent(boat, one -> new SampledField(plane.orElseThrow()))
                    .add(reading.position(), reading.values().get(0));
            measured = true;
        });
    }

    /** Forgets what was measured. */
    public void clear() {
        execute(() -> {
            fields.clear();
            plane = Optional.empty();
            measured = true;
            computedAtMillis = Long.MIN_VALUE / 2;
        });
    }

    /** These layers are shown from now on. */
    public void want(List<Request> layers) {
        wanted = List.copyOf(layers);
    }

    /** Computes the fields of shown layers, if something has changed and the last time is long enough ago. To be called often. */
    public void look(long nowMillis) {
        execute(() -> {
            List<Request> now = wanted;
            boolean changed = measured || !now.equals(answered);
            if (changed && nowMillis - computedAtMillis >= PERIOD_MILLIS) {
                measured = false;
                answered = now;
                computedAtMillis = nowMillis;
                computed.accept(List.copyOf(fields.keySet()), layers(now));
            }
        });
    }

    /**
     * Computes a layer that somebody looks at beside those that are shown, of all boats. Completes on the computing executor; never where the session has ended.
     *
     * @param word names the sensor or channel; empty text for the first channel
     * @return empty where nothing of that name was measured
     */
    public CompletionStage<Optional<SensorLayer>> layer(String word, Visualization visualization) {
        CompletableFuture<Optional<SensorLayer>> layer = new CompletableFuture<>();
        execute(() -> layer.complete(
                layers(List.of(new Request(word, visualization, Set.of(), OptionalDouble.empty(), ""))).stream()
                        .findFirst()));
        return layer;
    }

    private void execute(Runnable work) {
        try {
            computing.execute(work);
        } catch (RejectedExecutionException stopped) {
            // the session has ended: nobody looks at the map
        }
    }

    private List<SensorLayer> layers(List<Request> now) {
        List<SensorLayer> layers = new ArrayList<>();
        for (Request one : now) {
            fields.entrySet().stream()
                    .filter(channel -> isMeant(channel, one))
                    .findFirst()
                    .flatMap(channel -> layer(channel.getKey(), channel.getValue(), one))
                    .ifPresent(layers::add);
        }
        return layers;
    }

    private static boolean isMeant(Map.Entry<SensorChannel, Map<String, SampledField>> channel, Request one) {
        boolean called = one.word().isEmpty() || channel.getKey().isCalled(one.word());
        return called
                && (one.boats().isEmpty()
                        || channel.getValue().keySet().stream().anyMatch(one.boats()::contains));
    }

    private Optional<SensorLayer> layer(SensorChannel channel, Map<String, SampledField> byBoat, Request one) {
        SampledField all = new SampledField(plane.orElseThrow());
        for (Map.Entry<String, SampledField> boat : byBoat.entrySet()) {
            if (one.boats().isEmpty() || one.boats().contains(boat.getKey())) {
                all = all.and(boat.getValue());
            }
        }
        return all.grid().map(grid -> layer(channel, grid, one));
    }

    private static SensorLayer layer(SensorChannel channel, FieldGrid grid, Request one) {
        Legend legend = Legend.of(grid, channel.unit());
        List<ContourLine> contours = one.visualization() == Visualization.CONTOUR
                ? legend.marks().stream()
                        .map(mark -> ContourLine.of(grid, mark))
                        .toList()
                : List.of();
        double threshold = one.threshold().orElse((grid.least() + grid.greatest()) / 2);
        return new SensorLayer(channel, one.visualization(), grid, contours, threshold, legend, one.why());
    }
}
