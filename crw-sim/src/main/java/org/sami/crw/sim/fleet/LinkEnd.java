package org.sami.crw.sim.fleet;

import java.util.ArrayDeque;
import java.util.Deque;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.Traffic;
import org.sami.boat.server.ServerSession;

/**
 * A boat's end of its link, which lets boats be ticked side by side: news of others that came since the last tick are taken up in the boat's own tick, as
 * they cost most of what arrives, and what the boat says in its tick is kept until the clock's thread sends it. All arrives in the same order, and as of the
 * same time, as without it.
 */
final class LinkEnd implements FrameSink {
    private final FrameSink toBase;
    private final Deque<Arrived> traffic = new ArrayDeque<>();
    private final Deque<Frame> said = new ArrayDeque<>();
    private ServerSession session;
    private boolean isTicking;

    private record Arrived(Frame frame, long atMs) {}

    LinkEnd(FrameSink toBase) {
        this.toBase = toBase;
    }

    /** From now on this session takes what arrives. */
    void connect(ServerSession newSession) {
        session = newSession;
    }

    /** A frame has arrived. Traffic is answered by nothing, and nobody else sees whether the boat knows of it yet. */
    void receive(Frame frame, long nowMs) {
        if (frame.message() instanceof Traffic) {
            traffic.add(new Arrived(frame, nowMs));
        } else {
            takeTraffic();
            session.receive(frame, nowMs);
        }
    }

    private void takeTraffic() {
        for (Arrived next = traffic.poll(); next != null; next = traffic.poll()) {
            session.receive(next.frame, next.atMs);
        }
    }

    /** The boat is about to be ticked, on the thread that calls this. */
    void beginTick() {
        isTicking = true;
        takeTraffic();
    }

    /** The boat has been ticked: what it said is sent, on the clock's thread. */
    void endTick() {
        isTicking = false;
        for (Frame next = said.poll(); next != null; next = said.poll()) {
            toBase.send(next);
        }
    }

    @Override
    public void send(Frame frame) {
        if (isTicking) {
            said.add(frame);
        } else {
            toBase.send(frame);
        }
    }

    /** What is bytes already answers what could not be read, and nothing is read in a tick. */
    @Override
    public void send(byte[] frame) {
        toBase.send(frame);
    }
}
