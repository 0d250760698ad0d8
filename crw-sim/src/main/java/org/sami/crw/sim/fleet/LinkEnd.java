package org.sami.crw.sim.fleet;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameSink;
import org.sami.boat.server.ServerSession;

/**
 * A boat's end of its link, which lets the boat be ticked while the base goes on (docs/decisions, 0316): what arrives waits until the boat's next tick
 * begins, and what the boat says in a tick is kept until the clock's thread sends it.
 */
final class LinkEnd implements FrameSink {
    private final FrameSink toBase;
    private List<Frame> arriving = new ArrayList<>(); // for the clock's thread
    private List<Frame> arrived = new ArrayList<>(); // for the thread that ticks the boat, while it does
    private final List<Frame> said = new ArrayList<>(); // likewise
    private @Nullable ServerSession session; // null until the boat has connected it

    LinkEnd(FrameSink toBase) {
        this.toBase = toBase;
    }

    /** From now on this session takes what arrives. */
    void connect(ServerSession newSession) {
        session = newSession;
    }

    /** A frame has arrived: the boat takes it in with the next tick that begins. */
    void receive(Frame frame) {
        arriving.add(frame);
    }

    /** A tick is about to begin: what has arrived until now is the boat's. */
    void beginTick() {
        if (!arriving.isEmpty()) { // mostly nothing has: what one thread writes, the other one's core has to fetch
            List<Frame> emptied = arrived;
            arrived = arriving;
            arriving = emptied;
        }
    }

    /** The boat takes in what had arrived, on the thread that ticks it. */
    void takeIn(long nowMs) {
        if (session != null && !arrived.isEmpty()) {
            for (Frame frame : arrived) {
                session.receive(frame, nowMs);
            }
            arrived.clear();
        }
    }

    /** The tick is over: sends the boat's messages, on the clock's thread. */
    void endTick() {
        if (!said.isEmpty()) {
            for (Frame frame : said) {
                toBase.send(frame);
            }
            said.clear();
        }
    }

    @Override
    public void send(Frame frame) {
        said.add(frame);
    }

    /** Only what came as bytes is answered by bytes, and nothing comes so. */
    @Override
    public void send(byte[] frame) {
        throw new UnsupportedOperationException("this link carries no bytes");
    }
}
