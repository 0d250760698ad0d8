package org.sami.crw.report;

import java.util.List;

/**
 * A part of a report that is one record: it says by itself how it stands in the JSON object, in the text and in a table, so that who adds a figure adds a
 * record, and the fold that fills it, and changes no writer.
 */
public interface ReportPart {
    /** Name of its member in the JSON object, and of the file with its table. */
    String name();

    /** The value of the member: records, whose components are written in order under their names. */
    List<?> json();

    /** What the text says of it; no lines where there is nothing to say. */
    default List<String> lines() {
        return List.of();
    }

    /** The head of its table. */
    List<String> columns();

    /** The rows of its table, each with a cell for every column. */
    List<List<Object>> rows();
}
