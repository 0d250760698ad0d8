package org.sami.crw.proxy;

import java.util.List;
import java.util.Objects;
import java.util.function.Consumer;
import org.sami.spn.value.GeoPoint;

/**
 * Connects a base to more boats while missions run. A connected boat is in the base's {@link ProxyRegistry}, and its listener hears of its link like
 * any other's. For the fleet's thread.
 */
public interface BoatConnector {
    /** The most simulated boats that are made at once: as many as a base was measured with. */
    int MOST_CREATED = 250;

    /** For a base whose boats are fixed before it starts. */
    BoatConnector NONE = new BoatConnector() {
        @Override
        public void connect(Request request, Consumer<String> found) {
            throw new IllegalStateException("this base connects to no boats while it runs");
        }

        @Override
        public List<String> create(String name, String color, GeoPoint start, int count) {
            throw new IllegalStateException("this base makes no boats");
        }
    };

    /**
     * A boat to which a plan connects.
     *
     * @param name the plan's name for it; the boat may have another name
     * @param color such as {@code #ffce00}; empty for none
     * @param server host and port of its server
     */
    record Request(String name, String color, String server) {
        public Request {
            Objects.requireNonNull(name, "name");
            Objects.requireNonNull(color, "color");
            Objects.requireNonNull(server, "server");
        }
    }

    /**
     * Starts to connect to a boat's server, and keeps trying. A known boat is found at once.
     *
     * @param found receives the boat's id once it is known, on the fleet's thread
     * @throws RuntimeException with the reason, where connecting is impossible
     */
    void connect(Request request, Consumer<String> found);

    /**
     * Makes simulated boats and begins to connect to them.
     *
     * @param start where the first lies
     * @return their ids, in order
     * @throws RuntimeException saying why there are none
     */
    List<String> create(String name, String color, GeoPoint start, int count);
}
