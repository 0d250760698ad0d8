package org.sami.crw.sim.picture;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Supplier;
import org.sami.boat.server.picture.PictureFolder;
import org.sami.boat.server.vehicle.Camera;
import org.sami.boat.server.vehicle.CameraShot;
import org.sami.crw.sim.picture.Scene.SeenBoat;

/**
 * The camera of a boat in simulated time: it only records the scene, and the picture is drawn when it is fetched. So a run whose pictures are not fetched takes
 * no longer, and equal runs have equal pictures. It remembers as many scenes as a boat keeps pictures.
 *
 * <p>{@link #take} is for the thread that ticks the boat, all else for the clock's.
 */
public final class RecordingCamera implements Camera {
    private final String boat;
    private final Supplier<Scene> ahead;
    private final List<String> unfinished = new ArrayList<>();
    private final Map<String, Scene> scenes = new LinkedHashMap<>();
    private long taken;

    /**
     * A camera without pictures.
     *
     * @param ahead what is before it now, without the other boats
     */
    public RecordingCamera(String boat, Supplier<Scene> ahead) {
        this.boat = boat;
        this.ahead = ahead;
    }

    @Override
    public CameraShot take() {
        taken++;
        String name = boat.replaceAll("[^A-Za-z0-9_]", "_") + String.format(Locale.ROOT, "-%06d.jpg", taken);
        scenes.put(name, ahead.get());
        unfinished.add(name);
        if (scenes.size() > PictureFolder.MOST_FILES) {
            scenes.remove(scenes.keySet().iterator().next());
        }
        CameraShot shot = CameraShot.begun(name);
        shot.setKept();
        return shot;
    }

    /** The moment is over in which pictures may have been taken: adds the other boats, which moved during it on other threads. */
    public void finish(Function<String, List<SeenBoat>> others) {
        if (unfinished.isEmpty()) {
            return;
        }
        List<SeenBoat> seen = others.apply(boat);
        unfinished.forEach(name -> scenes.computeIfPresent(name, (same, scene) -> scene.with(seen)));
        unfinished.clear();
    }

    /** The scene of a picture; empty if it is no longer stored. */
    public Optional<Scene> scene(String name) {
        return Optional.ofNullable(scenes.get(name));
    }
}
