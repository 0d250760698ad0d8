package org.sami.session.server;

import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.sami.crw.markup.MapRelevance.Visualization;
import org.sami.crw.operator.map.SensorLayer;
import org.sami.crw.session.Session;
import org.sami.session.api.RefusedException;
import org.sami.session.rows.LayerJson;

/** Layers of readings that fronts ask for; one that was computed a moment ago is given again. For the server's thread. */
final class LayerCommands {
    private static final long FRESH_MS = 1000;
    private static final int MOST_KEPT = 8;

    private final Session session;
    private final Map<Wanted, Kept> kept = new LinkedHashMap<>();

    private record Wanted(String sensor, Visualization visualization) {}

    private record Kept(long atMillis, CompletionStage<Optional<SensorLayer>> layer) {}

    LayerCommands(Session session) {
        this.session = session;
    }

    /** The layer that a front asks for; refused where nothing of that name was measured. */
    CompletionStage<CommandReply> layer(FrontMessage message) throws MalformedMessageException {
        String sensor = message.text("sensor");
        Visualization visualization = visualization(message);
        return layer(new Wanted(sensor, visualization))
                .thenCompose(found -> found.map(
                                one -> CompletableFuture.completedFuture(CommandReply.ofLayer(LayerJson.of(one))))
                        .orElseGet(() -> CompletableFuture.failedFuture(new RefusedException(
                                "No boat has measured " + (sensor.isEmpty() ? "anything" : sensor)))));
    }

    private CompletionStage<Optional<SensorLayer>> layer(Wanted wanted) {
        long now = session.scheduler().nowMs();
        kept.values().removeIf(one -> now - one.atMillis() >= FRESH_MS);
        Kept known = kept.get(wanted);
        if (known != null) {
            return known.layer();
        }
        CompletionStage<Optional<SensorLayer>> made =
                session.models().map().layer(wanted.sensor(), wanted.visualization());
        if (kept.size() < MOST_KEPT) {
            kept.put(wanted, new Kept(now, made));
        }
        return made;
    }

    private static Visualization visualization(FrontMessage message) throws MalformedMessageException {
        String word = message.textIfThere("visualization").orElse("heatmap");
        for (Visualization one : Visualization.values()) {
            if (one.name().toLowerCase(Locale.ROOT).equals(word)) {
                return one;
            }
        }
        throw new MalformedMessageException("'visualization' is heatmap, contour or threshold");
    }
}
