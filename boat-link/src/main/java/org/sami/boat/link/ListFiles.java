package org.sami.boat.link;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;

/** Asks which files the boat keeps; {@link FileList} answers. */
public final class ListFiles extends FileRequest {
    static final String TYPE = "list-files";

    private final String kind;
    private final String after;

    /**
     * A request for one page of the list, which is in the order of the names.
     *
     * @param kind of the files, such as {@link KeptFile#LOG}; empty for all
     * @param after the page begins after this name; empty for the first page
     */
    public ListFiles(String requestId, String kind, String after) {
        super(requestId);
        this.kind = Checks.optionalId("kind", kind);
        this.after = Checks.optionalId("after", after);
    }

    static ListFiles read(Fields in) throws LinkException {
        return new ListFiles(in.text("request"), in.text("kind"), in.text("after"));
    }

    /** Kind of the files; empty for all. */
    public String kind() {
        return kind;
    }

    /** The page begins after this name; empty for the first page. */
    public String after() {
        return after;
    }

    @Override
    public String type() {
        return TYPE;
    }

    @Override
    void writeRequest(JsonGenerator out) throws IOException {
        out.writeStringField("kind", kind);
        out.writeStringField("after", after);
    }
}
