/*
 * val_xml.c: an XML text as elements in the order of the file, each with its attributes and its text.
 */
#include <expat.h>
#include <string.h>

#include "valentina/val_file.h"

#define XML_ELEMENTS 500000 /* most elements; chosen: the largest pattern known has 60000 */
#define XML_DEPTH 64        /* deepest element; those of real patterns are 7 deep */

typedef struct xml_reader {
    mus__val_xml *xml;
    XML_Parser parser;
    mus_status status;
    int32_t depth;
    int32_t open[XML_DEPTH];
} xml_reader;


static void xml_fail(xml_reader *r, mus_status status, const char *what)
{
    if (r->status != MUS_OK) return;
    const int64_t line = (int64_t)XML_GetCurrentLineNumber(r->parser);
    r->status = what != NULL ? mus__source_fail(r->xml->source, line, status, "%s", what) : status;
    XML_StopParser(r->parser, XML_FALSE);
}


/* keep a text; returns its offset */
static int32_t xml_keep(xml_reader *r, const char *text, size_t n)
{
    mus__val_xml *xml = r->xml;
    const int32_t at = xml->nbyte;
    const mus_status status =
        mus__source_reserve(xml->source, &xml->bytes, &xml->byte_room, (int64_t)at + (int64_t)n + 1, 1);
    if (status != MUS_OK) {
        xml_fail(r, status, NULL);
        return 0;
    }
    memcpy(xml->bytes + at, text, n);
    xml->bytes[at + (int64_t)n] = '\0';
    xml->nbyte += (int32_t)n + 1;
    return at;
}


static void XMLCALL xml_start(void *user, const XML_Char *name, const XML_Char **attributes)
{
    xml_reader *r = user;
    mus__val_xml *xml = r->xml;
    if (r->status != MUS_OK) return;
    if (r->depth == XML_DEPTH || xml->nelement == XML_ELEMENTS) {
        xml_fail(r, MUS_ERR_LIMIT, r->depth == XML_DEPTH ? "elements nested too deep" : "too many elements");
        return;
    }
    mus_status status = mus__source_reserve(xml->source, &xml->elements, &xml->element_room, (int64_t)xml->nelement + 1,
                                           sizeof *xml->elements);
    if (status != MUS_OK) {
        xml_fail(r, status, NULL);
        return;
    }
    mus__val_element *e = &xml->elements[xml->nelement];
    *e = (mus__val_element){.line = (int64_t)XML_GetCurrentLineNumber(r->parser), .depth = r->depth,
                            .first = xml->nattribute};
    const int32_t tag = xml_keep(r, name, strlen(name));
    e->end = tag; /* the tag's offset, until all texts are there */
    for (; attributes[0] != NULL && r->status == MUS_OK; attributes += 2) {
        const int32_t key = xml_keep(r, attributes[0], strlen(attributes[0]));
        const int32_t value = xml_keep(r, attributes[1], strlen(attributes[1]));
        status = mus__source_reserve(xml->source, &xml->attributes, &xml->attribute_room,
                                    2 * ((int64_t)xml->nattribute + 1), sizeof *xml->attributes);
        if (status != MUS_OK) {
            xml_fail(r, status, NULL);
            return;
        }
        xml->attributes[2 * (ptrdiff_t)xml->nattribute] = key;
        xml->attributes[2 * (ptrdiff_t)xml->nattribute++ + 1] = value;
        e->n++;
    }
    r->open[r->depth++] = xml->nelement++;
}


static void XMLCALL xml_end(void *user, const XML_Char *name)
{
    xml_reader *r = user;
    (void)name;
    if (r->depth > 0) r->depth--;
}


/* keep the first run of text of an element: units, names of files and of sizes are short */
static void XMLCALL xml_characters(void *user, const XML_Char *text, int length)
{
    xml_reader *r = user;
    if (r->status != MUS_OK || r->depth == 0) return;
    mus__val_element *e = &r->xml->elements[r->open[r->depth - 1]];
    int used = 0;
    while (used < length && strchr(" \t\r\n", text[used]) != NULL) used++;
    if (used == length) return;
    if (e->text == 0) {
        e->text = xml_keep(r, text + used, (size_t)(length - used));
        return;
    }
    /* expat gives a text in parts at line ends and character references: append while it is the last text */
    if ((int64_t)e->text + (int64_t)strlen(r->xml->bytes + e->text) + 1 == r->xml->nbyte) {
        r->xml->nbyte--;
        xml_keep(r, text, (size_t)length);
    }
}


static void XMLCALL xml_doctype(void *user, const XML_Char *name, const XML_Char *system, const XML_Char *public,
                                int internal)
{
    (void)name, (void)system, (void)public, (void)internal;
    xml_fail(user, MUS_ERR_FORMAT, "a document type declaration, expected none");
}


/* tags and ends of the elements, once no text moves any more */
static void xml_link(mus__val_xml *xml)
{
    for (int32_t i = 0; i < xml->nelement; i++) xml->elements[i].tag = xml->bytes + xml->elements[i].end;
    int32_t open[XML_DEPTH] = {0};
    for (int32_t i = 0, depth = 0; i <= xml->nelement; i++) {
        const int32_t now = i < xml->nelement ? xml->elements[i].depth : 0;
        while (depth > now) xml->elements[open[--depth]].end = i;
        if (i == xml->nelement) break;
        open[now] = i;
        depth = now + 1;
    }
    if (xml->nelement > 0) xml->elements[0].end = xml->nelement;
}


mus_status mus__val_xml_load(const mus__source *source, mus__val_xml *xml)
{
    *xml = (mus__val_xml){.source = source};
    xml_reader r = {.xml = xml};
    r.parser = XML_ParserCreate(NULL);
    if (r.parser == NULL) return mus__source_fail(source, 0, MUS_ERR_MEMORY, "no memory for the XML reader");
    xml_keep(&r, "", 0); /* the offset 0 is no text */
    XML_SetUserData(r.parser, &r);
    XML_SetElementHandler(r.parser, xml_start, xml_end);
    XML_SetCharacterDataHandler(r.parser, xml_characters);
    XML_SetStartDoctypeDeclHandler(r.parser, xml_doctype);
    const enum XML_Status parsed = XML_Parse(r.parser, source->text, (int)source->size, 1);
    if (parsed != XML_STATUS_OK && r.status == MUS_OK) {
        const enum XML_Error error = XML_GetErrorCode(r.parser);
        r.status = mus__source_fail(source, (int64_t)XML_GetCurrentLineNumber(r.parser),
                                    error == XML_ERROR_NO_MEMORY ? MUS_ERR_MEMORY : MUS_ERR_FORMAT, "expected XML: %s",
                                    XML_ErrorString(error));
    }
    XML_ParserFree(r.parser);
    if (r.status == MUS_OK) xml_link(xml);
    return r.status;
}


void mus__val_xml_free(mus__val_xml *xml)
{
    if (xml->source == NULL) return;
    mus_context *context = xml->source->context;
    mus_context_alloc(context, xml->elements, 0);
    mus_context_alloc(context, xml->attributes, 0);
    mus_context_alloc(context, xml->bytes, 0);
    *xml = (mus__val_xml){0};
}


const char *mus__val_attribute(const mus__val_xml *xml, int32_t element, const char *name)
{
    const mus__val_element *e = &xml->elements[element];
    for (int32_t i = e->first; i < e->first + e->n; i++)
        if (strcmp(xml->bytes + xml->attributes[2 * (ptrdiff_t)i], name) == 0)
            return xml->bytes + xml->attributes[2 * (ptrdiff_t)i + 1];
    return NULL;
}


const char *mus__val_text(const mus__val_xml *xml, int32_t element)
{
    return xml->bytes + xml->elements[element].text;
}


int32_t mus__val_child(const mus__val_xml *xml, int32_t parent, const char *tag, int32_t after)
{
    int32_t i = after == MUS_NONE ? parent + 1 : xml->elements[after].end;
    for (; i < xml->elements[parent].end; i = xml->elements[i].end)
        if (tag == NULL || strcmp(xml->elements[i].tag, tag) == 0) return i;
    return MUS_NONE;
}
