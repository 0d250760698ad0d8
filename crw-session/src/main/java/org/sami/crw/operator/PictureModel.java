package org.sami.crw.operator;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.FleetEvent.PanoramaTaken;
import org.sami.crw.fleet.FleetEvent.PictureFetched;
import org.sami.crw.fleet.FleetEvent.PictureMissed;
import org.sami.crw.operator.picture.BoatPicture;
import org.sami.crw.operator.picture.PanoramaPictures;

/** The pictures that boats have taken, the oldest first, and which of them are here. Follows the fleet's events; the oldest go when there are too many. */
public final class PictureModel extends Model<List<PanoramaPictures>> {
    private static final int MOST = 1000;

    private final Consumer<Runnable> inbox;
    private final Deque<PanoramaPictures> taken = new ArrayDeque<>();

    PictureModel(Consumer<Runnable> inbox) {
        super(List.of());
        this.inbox = inbox;
    }

    /** Whether an event changes something here. */
    static boolean concerns(FleetEvent event) {
        return event instanceof PanoramaTaken || event instanceof PictureFetched || event instanceof PictureMissed;
    }

    /** Takes up what happened before; from any thread. */
    public void restore(FleetEvent event, long atMillis) {
        inbox.accept(() -> apply(event, atMillis));
    }

    /** Something happened; events that do not concern pictures change nothing. */
    void apply(FleetEvent event, long atMillis) {
        if (event instanceof PanoramaTaken panorama) {
            add(panorama, atMillis);
        } else if (event instanceof PictureFetched fetched) {
            change(
                    fetched.boat(),
                    fetched.panorama(),
                    new BoatPicture(fetched.name(), Optional.of(fetched.file()), ""));
        } else if (event instanceof PictureMissed missed) {
            change(missed.boat(), missed.panorama(), new BoatPicture(missed.name(), Optional.empty(), missed.reason()));
        }
    }

    private void add(PanoramaTaken panorama, long atMillis) {
        if (panorama.files().isEmpty()) {
            return;
        }
        if (taken.size() == MOST) {
            taken.removeFirst();
        }
        taken.addLast(new PanoramaPictures(
                panorama.boat(),
                panorama.command().commandId(),
                panorama.command().mission(),
                atMillis,
                panorama.from(),
                panorama.files().stream().map(BoatPicture::coming).toList()));
        change();
    }

    /** Those that came last are looked at first. */
    private void change(String boat, String panorama, BoatPicture picture) {
        List<PanoramaPictures> all = new ArrayList<>(taken);
        for (int i = all.size() - 1; i >= 0; i--) {
            PanoramaPictures one = all.get(i);
            if (one.boat().equals(boat) && one.panorama().equals(panorama)) {
                all.set(i, one.with(picture));
                taken.clear();
                taken.addAll(all);
                change();
                return;
            }
        }
    }

    /** Forgets all. */
    void clear() {
        taken.clear();
        change();
    }

    @Override
    List<PanoramaPictures> take() {
        return List.copyOf(taken);
    }
}
