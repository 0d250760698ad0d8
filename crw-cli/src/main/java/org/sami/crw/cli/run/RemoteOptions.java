package org.sami.crw.cli.run;

import java.io.Console;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.output.Terminal;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.session.client.KnownServers;
import org.sami.session.client.Login;
import org.sami.session.client.RemoteListener;
import org.sami.session.client.RemoteSession;
import org.sami.session.client.ServerTrust;
import org.sami.session.client.SessionAddress;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Option;

/** The options of a front on a session in another process: where it is, who takes part. A key is in no option: others could see it in the list of processes. */
public final class RemoteOptions {
    private static final int LONGEST_KEY = 200;

    @Option(
            names = "--session",
            paramLabel = "ADDRESS",
            split = ",",
            description =
                    "Take part in a session that 'crw serve' runs elsewhere: wss://HOST:PORT, or ws://HOST:PORT on"
                            + " this machine. Of a session with standbys: one or several of its bases.")
    private List<String> addresses = new ArrayList<>();

    /** Why a certificate was not taken, and what to do; empty where none was refused. Written on threads of connections. */
    private volatile String notTrusted = "";

    @Option(
            names = "--person",
            paramLabel = "NAME",
            description = "Who takes part in it, as listed by 'crw people add'.")
    private @Nullable String person;

    @Option(
            names = "--key-file",
            paramLabel = "FILE",
            description = "The file with that person's key; else it is asked for at the terminal.")
    private @Nullable Path keyFile;

    @Option(
            names = "--certificate",
            paramLabel = "SHA-256",
            description = "The certificate that 'crw serve' printed, for the first connection; else it is shown and"
                    + " asked about at the terminal.")
    private @Nullable String certificate;

    /** Whether a session elsewhere is asked for. */
    public boolean isGiven() {
        return !addresses.isEmpty();
    }

    /**
     * Refuses options that a session elsewhere does not have, and those that only it has.
     *
     * @param also names of options that both have
     */
    public void check(CommandLine command, Set<String> also) {
        if (!isGiven()) {
            if (person != null || keyFile != null || certificate != null) {
                throw new UsageFault("--person, --key-file and --certificate go with --session");
            }
            return;
        }
        List<ArgSpec> given = command.getParseResult().matchedArgs();
        for (ArgSpec one : given) {
            boolean own = one.isOption()
                    && Set.of(((CommandLine.Model.OptionSpec) one).names()).stream()
                            .anyMatch(name -> also.contains(name)
                                    || Set.of("--session", "--person", "--key-file", "--certificate")
                                            .contains(name));
            if (!own) {
                String name = one.isOption() ? ((CommandLine.Model.OptionSpec) one).longestName() : one.paramLabel();
                throw new UsageFault(
                        name + " is for a session of this process: 'crw serve' takes it, --session does not");
            }
        }
        if (person == null) {
            throw new UsageFault("--session needs --person NAME");
        }
    }

    /**
     * Connects, and waits until the session is known here.
     *
     * @throws IOException in words, if it cannot be taken part in
     */
    public RemoteSession open(Executor front, RemoteListener listener) throws IOException, InterruptedException {
        List<SessionAddress> where;
        try {
            where = addresses.stream().map(SessionAddress::parse).toList();
        } catch (IllegalArgumentException unfit) {
            throw new UsageFault("--session: " + unfit.getMessage());
        }
        Login who = new Login(Optional.ofNullable(person).orElse(""), key());
        KnownServers known = new KnownServers(BaseProtection.folderOfThisUser().resolveSibling("session-servers"));
        try {
            return RemoteSession.open(
                    where, who, new ServerTrust(known, this::isRight), front, listener, LocalTime::now);
        } catch (IOException fault) {
            String why = notTrusted;
            if (why.isEmpty()) {
                throw fault;
            }
            throw new UsageFault(why);
        }
    }

    private String key() throws IOException {
        if (keyFile != null) {
            if (!Files.isReadable(keyFile)) {
                throw new UsageFault("--key-file: " + keyFile + " cannot be read");
            }
            if (Files.size(keyFile) > LONGEST_KEY) {
                throw new UsageFault("--key-file: " + keyFile + " is no key");
            }
            return Files.readString(keyFile, StandardCharsets.UTF_8).strip();
        }
        Optional<Console> terminal = terminal();
        if (terminal.isEmpty()) {
            return ""; // a session on this machine may need none
        }
        char[] typed = terminal.get().readPassword("key of %s (empty if the session needs none): ", person);
        return typed == null ? "" : new String(typed).strip();
    }

    private static Optional<Console> terminal() {
        return Terminal.onStandardInputAndOutput() ? Optional.ofNullable(System.console()) : Optional.empty();
    }

    private boolean isRight(String authority, String print) {
        if (certificate != null) {
            boolean right = certificate.equalsIgnoreCase(print);
            notTrusted = right ? "" : "--certificate: that of " + authority + " has another SHA-256, " + print;
            return right;
        }
        Optional<Console> terminal = terminal();
        if (terminal.isEmpty()) {
            notTrusted = authority + " is connected to for the first time: compare the SHA-256 of its certificate with"
                    + " the one that 'crw serve' printed; where it is the same: --certificate " + print;
            return false;
        }
        String typed = terminal.get()
                .readLine(
                        "%s is connected to for the first time. Its certificate has the SHA-256%n  %s%n"
                                + "Is that what 'crw serve' printed? (yes/no) ",
                        authority, print);
        return "yes".equals(typed);
    }
}
