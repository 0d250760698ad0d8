package org.sami.crw.cli.plan;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.option.PlanOption;
import org.sami.crw.cli.option.PlansArgument;
import org.sami.crw.cli.output.ExitCode;
import org.sami.picture.net.NetPicture;
import org.sami.spn.model.Plan;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code crw draw}: the picture of a net. */
@Command(
        name = "draw",
        mixinStandardHelpOptions = true,
        description = "Draws a plan's net as a picture: as its file lays it out, or else in layers from left to right.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {"0:it was drawn", "1:the file has errors", "2:wrong usage, or there is no such file"},
        footerHeading = "%nExamples:%n",
        footer = {"  crw draw clv --svg clv.svg", "  crw draw my-project.json --plan search --layout --png search.png"})
public final class DrawCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private PlansArgument plans = new PlansArgument();

    @Mixin
    private PlanOption planOption = new PlanOption();

    @Option(names = "--svg", paramLabel = "FILE", description = "Write the picture as SVG.")
    private @Nullable Path svg;

    @Option(names = "--png", paramLabel = "FILE", description = "Write the picture as PNG.")
    private @Nullable Path png;

    @Option(names = "--layout", description = "Lay it out in layers, whatever layout the file has.")
    private boolean layout;

    @Override
    public Integer call() throws IOException {
        if (svg == null && png == null) {
            throw new ParameterException(spec.commandLine(), "Where to? --svg FILE, --png FILE or both");
        }
        Optional<PlansArgument.Read> read = plans.read(spec.commandLine().getErr());
        if (read.isEmpty()) {
            return ExitCode.FINDINGS;
        }
        Plan plan = read.get().source().choose(planOption.name());
        NetPicture picture = NetPicture.of(plan, read.get().library().vocabulary(), layout);
        if (svg != null) {
            write(svg, picture.svg().getBytes(StandardCharsets.UTF_8));
        }
        if (png != null) {
            write(png, picture.png());
        }
        return ExitCode.OK;
    }

    private void write(Path file, byte[] bytes) throws IOException {
        boolean there = Files.exists(file);
        if (file.getParent() != null) {
            Files.createDirectories(file.getParent());
        }
        Files.write(file, bytes);
        PrintWriter out = spec.commandLine().getOut();
        out.println((there ? "replaced " : "written to ") + file);
        out.flush();
    }
}
