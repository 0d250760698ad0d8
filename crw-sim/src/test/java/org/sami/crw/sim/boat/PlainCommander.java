package org.sami.crw.sim.boat;

import java.io.BufferedInputStream;
import java.io.Closeable;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.net.Socket;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.sami.boat.link.Ack;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Role;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.link.Welcome;

/** A client that commands one boat over a plain link, one command after another, and notes how long each acknowledgement took. */
final class PlainCommander implements Closeable {
    final List<Long> acknowledgedAfterNanos = new ArrayList<>();
    private final Socket socket;
    private final FrameReader frames;
    private long sequence;
    private String term = "";
    private int uploads;

    PlainCommander(InetSocketAddress boat) throws IOException, LinkException {
        socket = new Socket(boat.getAddress(), boat.getPort());
        socket.setTcpNoDelay(true);
        frames = new FrameReader(new BufferedInputStream(socket.getInputStream()), LinkCodec.STANDARD);
        say(new Hello("", "commander", Role.COMMANDER, 10, ""));
        while (term.isEmpty()) {
            if (next() instanceof Welcome welcome) {
                term = welcome.term();
            }
        }
    }

    private void say(LinkMessage message) throws IOException {
        socket.getOutputStream().write(LinkCodec.STANDARD.encode(new Frame(sequence++, term, message)));
    }

    private LinkMessage next() throws IOException, LinkException {
        return LinkCodec.STANDARD.decode(frames.next().orElseThrow()).message();
    }

    /** Gives a command, and waits until the boat has acknowledged it. */
    void command(CommandMessage command) throws IOException, LinkException {
        long began = System.nanoTime();
        say(command);
        while (!(next() instanceof Ack ack && ack.commandId().equals(command.commandId()))) {
            // reports, and answers to others
        }
        acknowledgedAfterNanos.add(System.nanoTime() - began);
    }

    /** Uploads so many lists, each of about three kilobytes. */
    void upload(int count) throws IOException, LinkException {
        for (int i = 0; i < count; i++) {
            String id = "u" + uploads++;
            command(new UploadWaypoints(
                    id, id, Collections.nCopies(60, new Waypoint(45.123456789, 10.123456789, 1.5))));
        }
    }

    /** The ids of all commands so far. */
    List<String> ids() {
        List<String> ids = new ArrayList<>();
        for (int i = 0; i < uploads; i++) {
            ids.add("u" + i);
        }
        return ids;
    }

    /** The time in ms that all but a hundredth of the acknowledgements stayed under, from one on. */
    double p99Ms(int from) {
        List<Long> sorted = new ArrayList<>(acknowledgedAfterNanos.subList(from, acknowledgedAfterNanos.size()));
        Collections.sort(sorted);
        return sorted.get((int) (sorted.size() * 0.99)) / 1e6;
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }
}
