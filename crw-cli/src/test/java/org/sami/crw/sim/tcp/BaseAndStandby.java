package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalTime;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.sami.boat.server.testing.Await;
import org.sami.crw.cli.CrwProcess;
import org.sami.session.client.KnownServers;
import org.sami.session.client.Login;
import org.sami.session.client.RemoteSession;
import org.sami.session.client.ServerTrust;
import org.sami.session.client.SessionAddress;
import org.sami.session.client.testing.FrontNotices;

/** A base that holds a session and its standby, both processes on one journal in PostgreSQL, whose addresses are known before them; and a front. */
final class BaseAndStandby implements AutoCloseable {
    /** A machine with much else to do starts processes slowly. */
    static final double AT_MOST_S = 120;

    private final Path folder;
    private final ForwardedPort one = new ForwardedPort();
    private final ForwardedPort two = new ForwardedPort();
    private final List<CrwProcess> processes = new ArrayList<>();
    private final ExecutorService front = Executors.newSingleThreadExecutor();
    private final FrontNotices notices = new FrontNotices();

    /** Addresses of which nothing is behind yet. */
    BaseAndStandby(Path folder) throws IOException {
        this.folder = folder;
    }

    /** The address of the base that begins the session. */
    String first() {
        return one.address();
    }

    /** The address of its standby. */
    String second() {
        return two.address();
    }

    /** Starts the base that begins the session, and waits until it serves it. */
    CrwProcess serve(String journal, String... more) throws IOException {
        CrwProcess base = start(journal, more);
        one.leadTo(port(base, "the session is at "));
        return base;
    }

    /** Starts the standby, and waits until it knows who holds the session. */
    CrwProcess standBy(String journal) throws IOException {
        CrwProcess base = start(journal, "--standby");
        two.leadTo(port(base, "standby: it answers at "));
        await(base, "standby: the session is held by ");
        return base;
    }

    private CrwProcess start(String journal, String... more) throws IOException {
        List<String> line = new ArrayList<>(List.of("serve", "--port", "0", "--journal", journal));
        line.addAll(List.of("--bases", first() + "," + second()));
        line.addAll(List.of(more));
        return started(line);
    }

    private CrwProcess started(List<String> line) throws IOException {
        CrwProcess process = CrwProcess.start(folder, line);
        processes.add(process);
        return process;
    }

    /** Starts a console of ben's at the first base, which carries out some lines. */
    CrwProcess console(String... lines) throws IOException {
        Path script = Files.write(folder.resolve("script" + processes.size()), List.of(lines));
        return started(List.of("session", "--session", first(), "--person", "ben", "--script", script.toString()));
    }

    /** Takes part in the session as anna, at the first base. */
    RemoteSession front() throws Exception {
        ServerTrust trust = new ServerTrust(new KnownServers(folder.resolve("servers")), (authority, print) -> false);
        return RemoteSession.open(
                List.of(SessionAddress.parse(first())), new Login("anna", ""), trust, front, notices, LocalTime::now);
    }

    /** Waits until a process has said something. */
    static void await(CrwProcess process, String words) {
        Await.until("'" + words + "'", AT_MOST_S, () -> process.out().contains(words) || !process.isAlive());
        assertThat(process.out()).as(process.err()).contains(words);
    }

    private static int port(CrwProcess base, String words) {
        String before = words + "http://127.0.0.1:";
        await(base, before);
        String at = base.out().substring(base.out().indexOf(before) + before.length());
        return Integer.parseInt(at.substring(0, at.indexOf('/')));
    }

    /** What the front is told. */
    FrontNotices notices() {
        return notices;
    }

    @Override
    public void close() throws IOException {
        processes.forEach(CrwProcess::close);
        front.shutdown();
        one.close();
        two.close();
    }
}
