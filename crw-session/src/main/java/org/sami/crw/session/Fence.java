package org.sami.crw.session;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Function;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.operator.OperatorLog;
import org.sami.crw.operator.OperatorLogEntry;
import org.sami.crw.service.water.Water;
import org.sami.session.api.RefusedException;
import org.sami.spn.protocol.Input;
import org.sami.spn.value.GeoArea;

/** The area in which the boats of a session are to stay ({@link OperatingArea}). From any thread; what comes of it arrives where the session's results do. */
public final class Fence {
    private final Function<Input, CompletionStage<Void>> post;
    private final OperatorLog log;

    Fence(Function<Input, CompletionStage<Void>> post, OperatorLog log) {
        this.post = post;
        this.log = log;
    }

    /** Sets the area, instead of the project's. One that is no simple polygon is refused. */
    public CompletionStage<Void> set(GeoArea area) {
        try {
            Water.of(area.outline().get(0), List.of(), Optional.of(area));
        } catch (IllegalArgumentException crossed) {
            return CompletableFuture.failedFuture(new RefusedException(String.valueOf(crossed.getMessage())));
        }
        return post(
                OperatingArea.remember(area), "set the fence: " + area.outline().size() + " corners");
    }

    /** Takes the fence away: boats may go everywhere but into no-go areas. */
    public CompletionStage<Void> remove() {
        return post(OperatingArea.rememberNone(), "took the fence away");
    }

    /** The project's fence counts again. */
    public CompletionStage<Void> useProject() {
        return post(OperatingArea.rememberProject(), "took the project's fence");
    }

    private CompletionStage<Void> post(Input input, String words) {
        return post.apply(input).thenAccept(done -> log.add(OperatorLogEntry.Kind.FENCE, words));
    }
}
