package org.sami.crw.sim.picture;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.sami.crw.sim.picture.Scene.SeenBoat;

/** The positions of all boats of one simulated water, which their cameras draw. Safe for use by several threads. */
public final class BoatsInSight {
    private final Map<String, SeenBoat> boats = new ConcurrentHashMap<>();

    /** A boat is here now. */
    public void seen(SeenBoat boat) {
        boats.put(boat.name(), boat);
    }

    /** A boat has left the water. */
    public void gone(String boat) {
        boats.remove(boat);
    }

    /** All boats but one, by name. */
    public List<SeenBoat> others(String boat) {
        List<SeenBoat> others = new ArrayList<>(boats.values());
        others.removeIf(one -> one.name().equals(boat));
        others.sort(Comparator.comparing(SeenBoat::name));
        return others;
    }
}
