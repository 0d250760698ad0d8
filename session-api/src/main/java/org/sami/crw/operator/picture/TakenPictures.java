package org.sami.crw.operator.picture;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.fleet.FleetEvent.PanoramaTaken;
import org.sami.crw.fleet.FleetEvent.PictureFetched;
import org.sami.crw.fleet.FleetEvent.PictureMissed;

/** Collects the fleet's events about pictures; removes the oldest panoramas when there are too many. For one thread. */
public final class TakenPictures {
    private static final int MOST = 1000;

    private final List<PanoramaPictures> taken = new ArrayList<>();

    /** Whether an event changes something here. */
    public static boolean concerns(FleetEvent event) {
        return event instanceof PanoramaTaken || event instanceof PictureFetched || event instanceof PictureMissed;
    }

    /** Something happened; events that do not concern pictures change nothing. */
    public void apply(FleetEvent event, long atMillis) {
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
            taken.remove(0);
        }
        taken.add(new PanoramaPictures(
                panorama.boat(),
                panorama.command().commandId(),
                panorama.command().mission(),
                atMillis,
                panorama.from(),
                panorama.files().stream().map(BoatPicture::coming).toList()));
    }

    /** Searches the newest first. */
    private void change(String boat, String panorama, BoatPicture picture) {
        for (int i = taken.size() - 1; i >= 0; i--) {
            PanoramaPictures one = taken.get(i);
            if (one.boat().equals(boat) && one.panorama().equals(panorama)) {
                taken.set(i, one.with(picture));
                return;
            }
        }
    }

    /** Forgets all. */
    public void clear() {
        taken.clear();
    }

    /** All, the oldest first. */
    public List<PanoramaPictures> all() {
        return List.copyOf(taken);
    }
}
