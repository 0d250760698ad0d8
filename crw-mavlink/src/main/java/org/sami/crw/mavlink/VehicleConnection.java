package org.sami.crw.mavlink;

import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.sami.boat.link.Frame;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.crw.proxy.gateway.GatewayLink;
import org.sami.crw.proxy.gateway.LinkStatus;
import org.sami.spn.protocol.Priority;

/** The base's way to one vehicle, in memory: frames go in, and come out numbered. For the gateway's thread, but for what the base calls. */
final class VehicleConnection implements GatewayLink {
    /** Takes what the base says. */
    interface Receiver {
        void received(Frame frame);

        void closed();
    }

    private final InetSocketAddress address;
    private final Listener listener;
    private final Executor thread;
    private Optional<Receiver> receiver = Optional.empty();
    private long sent;
    private boolean over;
    private volatile List<LinkStatus> linkStatuses = List.of();

    VehicleConnection(InetSocketAddress address, Listener listener, Executor thread) {
        this.address = address;
        this.listener = listener;
        this.thread = thread;
    }

    /** The address that it was opened for. */
    InetSocketAddress address() {
        return address;
    }

    boolean isOver() {
        return over;
    }

    /** The vehicle is there: from now on it hears what the base says. */
    void open(Receiver to) {
        receiver = Optional.of(to);
        listener.opened();
    }

    /** One of the vehicles of an address of several. */
    void found(InetSocketAddress vehicle) {
        listener.found(vehicle);
    }

    void say(LinkMessage message) {
        if (!over) {
            listener.arrived(LinkCodec.STANDARD.encode(new Frame(sent++, "", message)));
        }
    }

    /** The links on which the vehicle is reached now. */
    void linkStatuses(List<LinkStatus> now) {
        linkStatuses = List.copyOf(now);
    }

    @Override
    public List<LinkStatus> linkStatuses() {
        return linkStatuses;
    }

    /** Says something to the operator. */
    void say(Priority priority, String text) {
        if (!over) {
            listener.said(priority, text);
        }
    }

    /** Ends it from the vehicle's side, for a reason in words. */
    void end(String why) {
        if (!over) {
            over = true;
            listener.closed(why);
        }
    }

    /** Ends it, as what answers there is not commanded, for a reason in words. */
    void refuse(String why) {
        if (!over) {
            over = true;
            listener.refused(why);
        }
    }

    @Override
    public void send(byte[] frame) {
        thread.execute(() -> {
            if (!over) {
                receiver.ifPresent(to -> take(frame, to));
            }
        });
    }

    /** What cannot be taken ends the connection: the base hears why, and says hello again, instead of waiting for an answer. */
    private void take(byte[] frame, Receiver to) {
        try {
            read(frame).ifPresent(to::received);
        } catch (RuntimeException e) {
            String vehicle = address.getHostString() + "/" + address.getPort();
            GuardedWork.log("the base's words to " + vehicle + " could not be taken", e);
            end("what the base said could not be taken: " + GuardedWork.words(e));
        }
    }

    private static Optional<Frame> read(byte[] frame) {
        try {
            return Optional.of(LinkCodec.STANDARD.decode(frame));
        } catch (LinkException e) {
            throw new IllegalStateException("the base sent a frame that cannot be read", e);
        }
    }

    @Override
    public void close() {
        thread.execute(() -> {
            if (!over) {
                over = true;
                receiver.ifPresent(Receiver::closed);
            }
        });
    }
}
