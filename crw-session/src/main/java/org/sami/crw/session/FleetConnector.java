package org.sami.crw.session;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.BoatConnector;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.crw.proxy.file.BoatFileSource;
import org.sami.crw.proxy.tcp.BaseListener;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.LinkReport;
import org.sami.crw.session.picture.PictureAccess;
import org.sami.spn.value.GeoPoint;

/**
 * The boats of a session and the ways to them: over TCP, or in a simulated world. By this and by its clock alone sessions in process
 * differ from those over TCP. For the fleet's thread, but for {@link #executor} and {@link #close}.
 */
public interface FleetConnector extends BoatConnector, AutoCloseable {
    /** Begins; the listener receives all events of boats and links, on the fleet's thread. Called once, on any thread. */
    void open(BaseListener listener);

    /** The fleet's thread. */
    Executor executor();

    /** The boats that are known. */
    ProxyRegistry boats();

    /** A boat of that name is known to be somewhere: it gets its proxy, whose commands wait until an address leads to it. */
    void expect(String boat);

    /**
     * Launches a simulated boat of an earlier process again, under its name.
     *
     * @throws IllegalStateException if it cannot be; the message says why
     */
    default void relaunch(String boat, GeoPoint at) {
        throw new IllegalStateException("this session has nobody who makes simulated boats");
    }

    /** Gives up a boat and its address: its commands fail, it is stopped if its link works. Gives whether it was known. */
    CompletionStage<Boolean> disconnect(String boat);

    /** Gives up an address, and the boat that it leads to. Gives whether it was known. */
    CompletionStage<Boolean> disconnect(BoatAddress address);

    /** How the links stand; from any thread. */
    CompletionStage<List<LinkReport>> links();

    /** How the links stand; empty where boats are reached without any. For the fleet's thread. */
    default List<LinkReport> linkReports() {
        return List.of();
    }

    /**
     * The files that a boat keeps, over a link that is not open yet; from any thread.
     *
     * @throws IllegalStateException where boats are reached without links, and {@link #links} names none
     */
    default BoatFileSource files(BoatAddress boat) {
        throw new IllegalStateException("boats in this process keep no files");
    }

    /** The area in which the robots of a kind may go from now on, for vehicles that keep to a fence by themselves; from any thread. */
    default void keepTo(OperatingArea area, RobotKind robots) {
        // simulated boats have no fence of their own
    }

    /** The way to the pictures that a boat keeps; empty while it is not reached, or where it keeps none. */
    default Optional<PictureAccess> pictures(String boat) {
        return Optional.empty();
    }

    @Override
    void close();
}
