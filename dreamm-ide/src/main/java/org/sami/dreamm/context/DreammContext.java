package org.sami.dreamm.context;

import java.util.Objects;
import java.util.Optional;
import org.sami.dreamm.document.EditorState;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.dreamm.profile.ProfileIds;
import org.sami.dreamm.wizard.Additions;
import org.sami.spn.component.ComponentChoice;
import org.sami.spn.component.ComponentLibrary;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditResult;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.spn.wiring.Wires;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.value.ValueContext;
import org.sami.ui.value.ValueEditors;
import org.sami.ui.window.Notices;

/** What all panels of a window work on. On the event thread. */
public final class DreammContext implements AutoCloseable {
    private final DomainSource source;
    private final DomainLibrary domain;
    private final ProjectDocument document;
    private final EditorState editor;
    private final Profile profile;
    private final CommandRegistry commands;
    private final Notices notices = new Notices();
    private final Questions questions = new Questions();
    private final TypedText typed = new TypedText();
    private final NetOverlay overlay = new NetOverlay();
    private final NetPreview preview = new NetPreview();
    private final BackgroundWork background = new BackgroundWork(notices::refused);
    private final ProjectMaps maps;
    private final ComponentLibrary components;
    private final ValueEditors values;
    private final Additions additions;

    /** The context of a window over a document, with the domain that ships. */
    public DreammContext(DomainLibrary domain, ProjectDocument document, Profile profile) {
        this(DomainSource.SHIPPED, domain, document, profile);
    }

    /**
     * The context of a window over a document.
     *
     * @param source where the domain comes from
     */
    public DreammContext(DomainSource source, DomainLibrary domain, ProjectDocument document, Profile profile) {
        this.source = Objects.requireNonNull(source, "source");
        this.domain = Objects.requireNonNull(domain, "domain");
        this.document = Objects.requireNonNull(document, "document");
        this.profile = Objects.requireNonNull(profile, "profile");
        editor = new EditorState(document);
        commands = new CommandRegistry(profile);
        maps = new ProjectMaps(document);
        components = domain.components().equals(ComponentLibrary.EMPTY)
                ? DomainSource.SHIPPED.library().orThrow().components() // as in the operator's window
                : domain.components();
        values = new ValueEditors(
                new ComponentChoice(components, domain.vocabulary().types()),
                new ValueContext(domain.vocabulary().types(), new ProjectNames(document, editor), maps));
        additions = new Additions(
                document,
                editor,
                domain.authoring(),
                wires(profile),
                !profile.shows(ProfileIds.SEQUENCES),
                this::apply);
    }

    /** Additions declare and read variables only where the author is given them. */
    private static Wires wires(Profile profile) {
        return profile.allows("event-field-sources")
                        && profile.allows("event-source-variable")
                        && profile.allows("event-source-task")
                ? Wires.PROPOSED
                : Wires.NONE;
    }

    /** The project that is written. */
    public ProjectDocument document() {
        return document;
    }

    /** What of it the author looks at. */
    public EditorState editor() {
        return editor;
    }

    /** What the author can have the window do. Their conditions are asked again when the document or the editor's state changes. */
    public CommandRegistry commands() {
        return commands;
    }

    /** What of the window the author is given. */
    public Profile profile() {
        return profile;
    }

    /** What lies over the net while a plan is tried. */
    public NetOverlay overlay() {
        return overlay;
    }

    /** What the open plan would be after an edit that the author thinks about. */
    public NetPreview preview() {
        return preview;
    }

    /** The status line: what was done, and why something was not. */
    public Notices notices() {
        return notices;
    }

    /** What the author is asked at the top of the window. */
    public Questions questions() {
        return questions;
    }

    /** What the author has typed and the project has not got yet. */
    public TypedText typed() {
        return typed;
    }

    /** Where the domain comes from. */
    public DomainSource source() {
        return source;
    }

    /** The domain as it ships: words, components, plans. */
    public DomainLibrary domain() {
        return domain;
    }

    /** The words of the domain. */
    public Vocabulary vocabulary() {
        return domain.vocabulary();
    }

    /** The components with which the domain's values are given. */
    public ComponentLibrary components() {
        return components;
    }

    /** Makes editors of values, for the open plan. */
    public ValueEditors values() {
        return values;
    }

    /** Makes maps of values, which open where the project's water is. */
    public ProjectMaps maps() {
        return maps;
    }

    /** Adds events and vertices to the open plan. */
    public Additions additions() {
        return additions;
    }

    /** Does what is slow off the event thread. */
    public BackgroundWork background() {
        return background;
    }

    /** Makes an edit and says in the status line what went along, or why it was refused. */
    public EditResult apply(Edit edit) {
        EditResult result = document.apply(edit);
        if (result instanceof EditResult.Refused refused) {
            notices.refused(refused.message());
        } else if (result instanceof EditResult.Done done) {
            notices.show(withRemarks(edit.label(), done));
        }
        return result;
    }

    /** Takes the last edit back and says so. */
    public void undo() {
        Optional<String> label = document.undoLabel();
        document.undo().ifPresent(done -> notices.show(withRemarks("Undone: " + label.orElse(""), done)));
    }

    /** Makes the edit again that was taken back last, and says so. */
    public void redo() {
        Optional<String> label = document.redoLabel();
        document.redo().ifPresent(done -> notices.show(withRemarks("Done again: " + label.orElse(""), done)));
    }

    private static String withRemarks(String label, EditResult.Done done) {
        return done.remarks().isEmpty() ? label : label + " – " + String.join("; ", done.remarks());
    }

    /** Ends what works off the event thread. */
    @Override
    public void close() {
        maps.keepLast();
        background.close();
    }
}
