package org.sami.crw.handler;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.sami.crw.fleet.FleetEvent;
import org.sami.crw.handler.motion.BoatErrors;
import org.sami.crw.handler.motion.LaterMoves;
import org.sami.crw.handler.motion.MotionCommands;
import org.sami.crw.handler.planning.Computations;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.crw.message.MessageSink;
import org.sami.crw.proxy.ProxyRegistry;
import org.sami.spn.host.ActivationHandler;
import org.sami.spn.host.EngineHost;
import org.sami.spn.host.HostListener;

/**
 * What the handlers of a domain may use, and where they are added.
 *
 * @param host their engine's host
 * @param robots the proxies of all robots
 * @param fleet the serial executor on which handlers run and proxies live
 * @param messages to the operator
 * @param motion gives robots commands and posts the plan's answers
 * @param computations runs long computations off the fleet's thread
 * @param services planning
 * @param errors how far robots may be off their paths, in metres
 * @param added receives what is added
 */
public record HandlerParts(
        EngineHost host,
        ProxyRegistry robots,
        Executor fleet,
        MessageSink messages,
        MotionCommands motion,
        Computations computations,
        CrwServices services,
        BoatErrors errors,
        Added added) {

    /** What a domain adds. */
    static final class Added {
        final Map<String, ActivationHandler> handlers = new LinkedHashMap<>();
        final Set<String> motion = new HashSet<>();
        final List<Consumer<FleetEvent>> fleetListeners = new ArrayList<>();
        final List<HostListener> hostListeners = new ArrayList<>();
        final List<LaterMoves> laterMoves = new ArrayList<>();
    }

    /** Adds a handler of an output event that moves robots: its commands are withdrawn with the mission. */
    public void addMotion(String type, ActivationHandler handler) {
        added.motion.add(type);
        add(type, handler);
    }

    /** Adds a handler of an output event. */
    public void add(String type, ActivationHandler handler) {
        if (added.handlers.put(type, handler) != null) {
            throw new IllegalArgumentException(type + " has two handlers");
        }
    }

    /** Adds moves that are sent later, which aborts are to reach. */
    public void addLater(LaterMoves moves) {
        added.laterMoves.add(moves);
    }

    /** Adds a listener of events of robots; called on the fleet's thread. */
    public void listen(Consumer<FleetEvent> listener) {
        added.fleetListeners.add(listener);
    }

    /** Adds a listener of the engine's steps; called on the engine's thread. */
    public void listen(HostListener listener) {
        added.hostListeners.add(listener);
    }
}
