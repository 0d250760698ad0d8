package org.sami.dreamm.export;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.OptionalDouble;
import javax.swing.JFileChooser;
import javax.swing.filechooser.FileNameExtensionFilter;
import org.sami.dreamm.context.DreammContext;
import org.sami.picture.NetFonts;
import org.sami.picture.net.NetPicture;
import org.sami.spn.drawing.NetDetail;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.model.Plan;
import org.sami.ui.command.Command;

/** The commands that write the open plan as a picture. */
public final class ExportCommands {
    private final DreammContext context;

    private ExportCommands(DreammContext context) {
        this.context = context;
    }

    /** Registers them. */
    public static void addTo(DreammContext context) {
        ExportCommands commands = new ExportCommands(context);
        for (PictureFormat format : PictureFormat.values()) {
            context.commands()
                    .add(new Command(
                                    "plan-export-" + format.suffix(),
                                    "Export the plan as " + format.label() + "…",
                                    () -> commands.choose(format))
                            .withKey(key(format))
                            .withIcon("export")
                            .unless(() -> context.editor().plan().isPresent()
                                    ? Optional.empty()
                                    : Optional.of("no plan is open")));
        }
    }

    private static String key(PictureFormat format) {
        return switch (format) {
            case PNG -> "alt shift I";
            case SVG -> "alt shift V";
            case PDF -> "alt shift D";
        };
    }

    private void choose(PictureFormat format) {
        Plan plan = context.editor().plan().orElseThrow();
        File folder = context.document()
                .file()
                .map(file ->
                        Files.isDirectory(file) ? file.toFile() : file.toFile().getParentFile())
                .orElse(null);
        JFileChooser chooser = new JFileChooser(folder);
        chooser.setDialogTitle("Export " + plan.title() + " as " + format.label());
        chooser.setFileFilter(new FileNameExtensionFilter(format.label(), format.suffix()));
        chooser.setSelectedFile(new File(chooser.getCurrentDirectory(), plan.id() + "." + format.suffix()));
        if (chooser.showSaveDialog(null) == JFileChooser.APPROVE_OPTION) {
            export(plan, format, chooser.getSelectedFile().toPath());
        }
    }

    private void export(Plan plan, PictureFormat format, Path chosen) {
        String name = chosen.getFileName().toString();
        Path file = name.contains(".") ? chosen : chosen.resolveSibling(name + "." + format.suffix());
        boolean there = Files.exists(file);
        context.background()
                .run(
                        "Exporting " + plan.title(),
                        () -> {
                            try {
                                Files.write(file, bytes(context, plan, format));
                                return file;
                            } catch (IOException fault) {
                                throw new UncheckedIOException(file + ": " + fault.getMessage(), fault);
                            }
                        },
                        written -> context.notices()
                                .show((there ? "Replaced " : "Exported ") + plan.title() + " as " + written));
    }

    /** The picture of a plan, where it lies on the canvas. */
    static byte[] bytes(DreammContext context, Plan plan, PictureFormat format) throws IOException {
        return format.write(new NetPicture(NetLayout.edited(
                plan, context.vocabulary(), NetFonts::width, NetDetail.READER, OptionalDouble.empty())));
    }
}
