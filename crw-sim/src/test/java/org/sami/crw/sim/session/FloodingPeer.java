package org.sami.crw.sim.session;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicLong;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BatteryReport;
import org.sami.boat.link.CommandAsked;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FrameReader;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Progress;
import org.sami.boat.link.SensorReport;
import org.sami.boat.link.Welcome;
import org.sami.crw.proxy.tcp.BoatAddress;

/**
 * What answers as a boat, takes every command, and says as fast as it can what boats say seldom: readings of ever new channels, a battery
 * that changes its class, clients that wish to command. So many messages in all; then it falls silent.
 */
final class FloodingPeer implements AutoCloseable {
    final ConcurrentLinkedQueue<String> commands = new ConcurrentLinkedQueue<>();
    final AtomicLong sent = new AtomicLong();
    private final ServerSocket socket = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
    private final String boatId;
    private final long most;

    FloodingPeer(String boatId, long most) throws IOException {
        this.boatId = boatId;
        this.most = most;
        daemon("accepts", this::accept);
    }

    BoatAddress address() {
        return new BoatAddress("127.0.0.1", socket.getLocalPort());
    }

    private void daemon(String what, Runnable work) {
        Thread thread = new Thread(work, boatId + "-" + what);
        thread.setDaemon(true);
        thread.start();
    }

    private void accept() {
        while (!socket.isClosed()) {
            try {
                Socket base = socket.accept();
                Mouth mouth = new Mouth(base.getOutputStream());
                daemon("answers", () -> answer(base, mouth));
            } catch (IOException closed) {
                return;
            }
        }
    }

    private void answer(Socket base, Mouth mouth) {
        boolean floods = false;
        try (base) {
            FrameReader frames = new FrameReader(new BufferedInputStream(base.getInputStream()), new LinkCodec());
            for (Optional<byte[]> next = frames.next(); next.isPresent(); next = frames.next()) {
                LinkMessage message = LinkCodec.STANDARD.decode(next.get()).message();
                if (message instanceof Hello hello) {
                    mouth.say(new Welcome(boatId, "boot", hello.role(), "boot.1", "", false));
                    mouth.say(new Progress("", 0, false));
                    if (!floods && !hello.boatId().isEmpty()) {
                        floods = true;
                        daemon("floods", () -> flood(mouth));
                    }
                } else if (message instanceof CommandMessage command) {
                    commands.add(command.type());
                    mouth.say(new Ack(command.commandId()));
                }
                mouth.flush();
            }
        } catch (IOException | LinkException closed) {
            // the base or the test has had enough
        }
    }

    private void flood(Mouth mouth) {
        try {
            for (long i = sent.getAndIncrement(); i < most; i = sent.getAndIncrement()) {
                mouth.say(message(i));
            }
            sent.set(most);
            mouth.flush();
        } catch (IOException closed) {
            // it goes on over the next connection
        }
    }

    private LinkMessage message(long i) {
        return switch ((int) (i % 10)) {
            case 0 ->
                new BatteryReport(i % 20 == 0 ? 90 : 10, i % 20 == 0 ? BatteryLevel.NOMINAL : BatteryLevel.CRITICAL);
            case 1 -> new CommandAsked("client" + i);
            case 2, 3, 4 -> new SensorReport("sonde", "depth", List.of((double) i), "m", 45.4, 10.9, i);
            default -> new SensorReport("sonde", "channel " + i, List.of(i / 3.0), "m", 45.4, 10.9, i);
        };
    }

    @Override
    public void close() throws IOException {
        socket.close();
    }

    /** The frames to one base, which two threads say. */
    private static final class Mouth {
        private final OutputStream out;
        private long sequence;

        Mouth(OutputStream out) {
            this.out = new BufferedOutputStream(out, 1 << 16);
        }

        synchronized void say(LinkMessage message) throws IOException {
            out.write(LinkCodec.STANDARD.encode(sequence++, message));
        }

        synchronized void flush() throws IOException {
            out.flush();
        }
    }
}
