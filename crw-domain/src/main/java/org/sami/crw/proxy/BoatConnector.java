package org.sami.crw.proxy;

import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import org.sami.spn.value.GeoPoint;

/**
 * How a base gets to boats that it does not have yet, while missions run. A boat that it gets to is in the base's
 * {@link ProxyRegistry}, and its listener is told of its link as of any other's. For the fleet's thread.
 */
public interface BoatConnector {
    /** The most simulated boats that are made at once: as many as a base was measured with. */
    int MOST_CREATED = 250;

    /** For a base whose boats are settled before it begins. */
    BoatConnector NONE = new BoatConnector() {
        @Override
        public void connect(Wanted wanted, Consumer<String> found) {
            throw new IllegalStateException("this base connects to no boats while it runs");
        }

        @Override
        public List<String> create(String name, String color, GeoPoint start, int count) {
            throw new IllegalStateException("this base makes no boats");
        }
    };

    /**
     * A boat that a plan wants to be connected to.
     *
     * @param name what the plan calls it; the boat may call itself otherwise
     * @param color such as {@code #ffce00}; empty where none is wanted
     * @param server host and port of its server
     */
    record Wanted(String name, String color, String server) {
        public Wanted {
            Objects.requireNonNull(name, "name");
            Objects.requireNonNull(color, "color");
            Objects.requireNonNull(server, "server");
        }
    }

    /**
     * Begins to connect to a boat's server, and keeps at it. A boat that is known already is found at once.
     *
     * @param found is told the boat's id, once, on the fleet's thread, when it is known
     * @throws RuntimeException saying why this cannot be tried
     */
    void connect(Wanted wanted, Consumer<String> found);

    /**
     * Makes simulated boats and begins to connect to them.
     *
     * @param start where the first lies
     * @return their ids, in order
     * @throws RuntimeException saying why there are none
     */
    List<String> create(String name, String color, GeoPoint start, int count);
}
