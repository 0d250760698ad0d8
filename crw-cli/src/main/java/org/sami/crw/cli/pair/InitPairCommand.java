package org.sami.crw.cli.pair;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.cert.CertificateEncodingException;
import java.util.Base64;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.security.Identity;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import org.sami.pair.postgres.Invitation;
import org.sami.pair.postgres.PairSecrets;
import org.sami.pair.postgres.PairSettings;
import org.sami.pair.postgres.PairSetup;
import org.sami.pair.postgres.WhenCut;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw pair init}. */
@Command(
        name = "init",
        mixinStandardHelpOptions = true,
        sortOptions = false,
        description = "Makes the database of a new pair on this base, and the file by which the second base joins it.")
final class InitPairCommand implements Callable<Integer> {
    private static final int PEM_LINE = 64;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private PairFolderOption folder = new PairFolderOption();

    @Mixin
    private ProgramsOption programs = new ProgramsOption();

    @Parameters(paramLabel = "HOST", description = "The address of the second base.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String other;

    @Option(
            names = "--here",
            paramLabel = "ADDRESS",
            description = "The address of this base, as the second reaches it (default: the one from which this base"
                    + " reaches the second).")
    private @Nullable String here;

    @Option(names = "--port", paramLabel = "N", description = "The port of both databases (default: ${DEFAULT-VALUE}).")
    private int port = 5440;

    @Option(
            names = "--when-cut",
            paramLabel = "RULE",
            description = "What happens where the bases do not reach one another, and neither knows whether the other"
                    + " died. take-over: the standby goes on by itself, and the base that has the session stops commanding"
                    + " before that. alone: the base that has the session goes on alone, and the standby only by 'crw"
                    + " take-over' (default: ${DEFAULT-VALUE}).")
    private String whenCut = WhenCut.TAKE_OVER.text();

    @Option(
            names = "--invitation",
            paramLabel = "FILE",
            description = "The file for the second base (default: ${DEFAULT-VALUE}).")
    private Path invitation = Path.of("sami-pair.invitation");

    @Override
    public Integer call() throws IOException {
        if (Files.exists(invitation)) {
            throw new UsageFault(invitation + " is there already; choose another file by --invitation");
        }
        PairSettings settings = UsageFault.of(() ->
                new PairSettings(here == null ? OwnAddress.towards(other) : here, other, port, WhenCut.parse(whenCut)));
        PairSecrets secrets = secrets();
        PairSetup.make(folder.folder(), programs.programs(), settings, secrets);
        new Invitation(settings.seenByOther(), secrets).write(invitation);
        PrintWriter out = spec.commandLine().getOut();
        out.println("made the database of a pair in " + folder.folder().path() + ": this base is " + settings.here()
                + ", the other " + settings.other() + ", port " + settings.port());
        out.println("bring " + invitation + " to " + other + ", as by a memory stick, and there: crw pair join "
                + invitation.getFileName());
        out.println("whoever has that file can read and write the session: delete it once it was used");
        return ExitCode.OK;
    }

    private static PairSecrets secrets() {
        Identity identity = Identity.generate();
        try {
            return PairSecrets.of(
                    pem("PRIVATE KEY", identity.key().getEncoded()),
                    pem("CERTIFICATE", identity.certificate().getEncoded()));
        } catch (CertificateEncodingException impossible) {
            throw new IllegalStateException("a certificate that was just made can be written", impossible);
        }
    }

    private static String pem(String what, byte[] bytes) {
        byte[] newLine = "\n".getBytes(StandardCharsets.US_ASCII);
        return "-----BEGIN " + what + "-----\n"
                + Base64.getMimeEncoder(PEM_LINE, newLine).encodeToString(bytes) + "\n-----END " + what + "-----\n";
    }
}
