package org.sami.crw.operator;

import java.util.List;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.operator.picture.PanoramaPictures;
import org.sami.crw.operator.picture.TakenPictures;

/** The pictures that boats have taken, the oldest first, and which of them are here. Follows the fleet's events. */
public final class PictureModel extends Model<List<PanoramaPictures>> {
    private final Consumer<Runnable> inbox;
    private final TakenPictures taken = new TakenPictures();

    PictureModel(Consumer<Runnable> inbox) {
        super(List.of());
        this.inbox = inbox;
    }

    /** Takes up what happened before; from any thread. */
    public void restore(FleetEvent event, long atMillis) {
        inbox.accept(() -> apply(event, atMillis));
    }

    /** Something happened; events that do not concern pictures change nothing. */
    void apply(FleetEvent event, long atMillis) {
        taken.apply(event, atMillis);
        change();
    }

    /** Forgets all. */
    void clear() {
        taken.clear();
        change();
    }

    @Override
    List<PanoramaPictures> take() {
        return taken.all();
    }
}
